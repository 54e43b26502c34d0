//! A hash table of numbers. The keys stay with the caller.

/// Finds numbers by the hashes of their keys. In an unoptimised build, the table of std costs several times as much.
#[derive(Clone, Debug, Default)]
pub(crate) struct HashIndex {
    /// Pairs of a hash and one plus a number, or [0, 0] where the place is free. The length is a power of two, and at most half of the places are
    /// taken. A pair is at the place of its hash, or at the next free place.
    places: Vec<[u32; 2]>,
    taken: usize,
}

impl HashIndex {
    /// Returns the number with this hash that `is_equal` accepts.
    pub(crate) fn find(&self, hash: u32, is_equal: impl Fn(usize) -> bool) -> Option<usize> {
        let places = self.places.as_slice();
        if places.is_empty() {
            return None;
        }
        let last = places.len() - 1;
        let mut place = hash as usize & last;
        loop {
            let [other, number] = places[place];
            if number == 0 {
                return None;
            }
            if other == hash && is_equal(number as usize - 1) {
                return Some(number as usize - 1);
            }
            place = (place + 1) & last;
        }
    }

    /// Adds a number. Precondition: the table does not contain its key.
    pub(crate) fn insert(&mut self, hash: u32, number: usize) {
        if 2 * self.taken >= self.places.len() {
            let larger = vec![[0; 2]; (4 * self.places.len()).max(1024)];
            let smaller = std::mem::replace(&mut self.places, larger);
            smaller.into_iter().filter(|[_, number]| *number > 0).for_each(|entry| put(&mut self.places, entry));
        }
        put(&mut self.places, [hash, number as u32 + 1]);
        self.taken += 1;
    }
}

/// Writes an entry to the first free place.
fn put(places: &mut [[u32; 2]], entry: [u32; 2]) {
    let last = places.len() - 1;
    let mut place = entry[0] as usize & last;
    while places[place][1] > 0 {
        place = (place + 1) & last;
    }
    places[place] = entry;
}
