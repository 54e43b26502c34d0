//! Bytes of machine code of a library.

use anyhow::Result;
use object::read::archive::ArchiveFile;
use object::{File, Object, ObjectSection, SectionKind};
use std::path::Path;

/// Returns the size of all executable sections of a Rust library.
pub(crate) fn bytes(library: &Path) -> Result<u64> {
    let content = std::fs::read(library)?;
    let mut sum = 0;
    for member in ArchiveFile::parse(&content[..])?.members() {
        // The archive also contains the metadata of the crate.
        if let Ok(object) = File::parse(member?.data(&content[..])?) {
            sum += object
                .sections()
                .filter(|section| section.kind() == SectionKind::Text)
                .map(|text| text.size())
                .sum::<u64>();
        }
    }
    Ok(sum)
}
