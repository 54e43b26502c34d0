//! What is known: a hash table of numbers, which are all that it holds.

/// The numbers of things by their hashes. In an unoptimised build std's table costs several times as much.
#[derive(Clone, Debug, Default)]
pub(crate) struct Known {
    /// A power of two of places, not more than half of them taken. A hash and one more than a number are at the place of the hash,
    /// or at the next free one, which is (0, 0).
    places: Vec<[u32; 2]>,
    taken: usize,
}

impl Known {
    /// The number with a hash for which something holds.
    pub(crate) fn find(&self, hash: u32, is: impl Fn(usize) -> bool) -> Option<usize> {
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
            if other == hash && is(number as usize - 1) {
                return Some(number as usize - 1);
            }
            place = (place + 1) & last;
        }
    }

    /// A number that is not known.
    pub(crate) fn insert(&mut self, hash: u32, number: usize) {
        if 2 * self.taken >= self.places.len() {
            let larger = vec![[0; 2]; (4 * self.places.len()).max(1024)];
            let smaller = std::mem::replace(&mut self.places, larger);
            for entry in smaller {
                if entry[1] > 0 {
                    put(&mut self.places, entry);
                }
            }
        }
        put(&mut self.places, [hash, number as u32 + 1]);
        self.taken += 1;
    }
}

fn put(places: &mut [[u32; 2]], entry: [u32; 2]) {
    let last = places.len() - 1;
    let mut place = entry[0] as usize & last;
    while places[place][1] > 0 {
        place = (place + 1) & last;
    }
    places[place] = entry;
}
