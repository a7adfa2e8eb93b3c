//! How much memory a solution may take.

/// Of what is free.
const SHARE: f64 = 0.8;
/// A node of a mesh that is solved takes at least this much.
const A_NODE: usize = 6_000;
/// Where nobody says how much is free.
const USUAL_NODES: usize = 500_000;

/// Bytes; `None` where the system does not say.
pub(crate) fn allowed() -> Option<usize> {
    let text = std::fs::read_to_string("/proc/meminfo").ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix("MemAvailable:"))?;
    let kibibytes: f64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some((SHARE * 1024.0 * kibibytes) as usize)
}

/// A mesh of more nodes is not worth making.
pub(crate) fn most_nodes() -> usize {
    allowed().map_or(USUAL_NODES, |bytes| bytes / A_NODE)
}
