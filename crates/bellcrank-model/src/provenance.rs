//! What made a result: version, file, hash of the text, date.

use std::time::{SystemTime, UNIX_EPOCH};

use bellcrank_doc::{SourceId, Sources};
use bellcrank_results::Provenance;

/// FNV-1a, 64 bits: tells texts apart, for those who do not try to deceive it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fingerprint(u64);

impl Default for Fingerprint {
    fn default() -> Fingerprint {
        Fingerprint(0xcbf2_9ce4_8422_2325)
    }
}

impl Fingerprint {
    pub(crate) fn bytes(&mut self, bytes: impl IntoIterator<Item = u8>) {
        const PRIME: u64 = 0x0000_0100_0000_01b3;
        self.0 = bytes.into_iter().fold(self.0, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(PRIME));
    }

    /// A text of a kind; where one ends and the next begins counts, too.
    pub(crate) fn words(&mut self, kind: &str, text: &str) {
        self.bytes(kind.bytes().chain([0]).chain(text.bytes()).chain([0]));
    }

    pub(crate) fn value(self) -> u64 {
        self.0
    }
}

/// The fingerprint of all texts in the order in which they were read; hex.
pub(crate) fn hash(sources: &Sources, ids: &[SourceId]) -> String {
    let mut fingerprint = Fingerprint::default();
    ids.iter().for_each(|&id| fingerprint.bytes(sources.text(id).bytes()));
    format!("{:016x}", fingerprint.value())
}

pub(crate) fn provenance(file: &str, hash: &str) -> Provenance {
    Provenance {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        file: file.to_owned(),
        hash: hash.to_owned(),
        date: now(),
    }
}

/// The time, ISO 8601 in UTC, to the second.
pub(crate) fn now() -> String {
    date(SystemTime::now())
}

/// ISO 8601 in UTC, to the second.
fn date(time: SystemTime) -> String {
    let seconds = time.duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs());
    let (days, rest) = (seconds / 86_400, seconds % 86_400);
    let (year, month, day) = civil(days);
    let (hour, minute, second) = (rest / 3600, rest / 60 % 60, rest % 60);
    format!("{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}Z")
}

/// Year, month and day of a number of days since 1970-01-01 (H. Hinnant, "chrono-compatible low-level date
/// algorithms"): years are counted from March, so that the leap day comes last.
fn civil(days: u64) -> (u64, u64, u64) {
    let shifted = days + 719_468;
    let (era, of_era) = (shifted / 146_097, shifted % 146_097);
    let year_of_era = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
    let day_of_year = of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let from_march = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * from_march + 2) / 5 + 1;
    let month = if from_march < 10 { from_march + 3 } else { from_march - 9 };
    (era * 400 + year_of_era + u64::from(month <= 2), month, day)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    #[test]
    fn dates_are_those_of_the_calendar() {
        let at = |seconds| date(UNIX_EPOCH + Duration::from_secs(seconds));
        assert_eq!(at(0), "1970-01-01T00:00:00Z");
        assert_eq!(at(951_782_399), "2000-02-28T23:59:59Z");
        assert_eq!(at(951_782_400), "2000-02-29T00:00:00Z");
        assert_eq!(at(1_798_761_599), "2026-12-31T23:59:59Z");
    }
}
