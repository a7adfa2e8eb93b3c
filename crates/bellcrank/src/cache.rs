//! Where reductions of flexible bodies outlive a run.

use std::ffi::OsString;
use std::path::PathBuf;

use crate::args::CacheArgs;

/// Names the folder, unless the arguments do.
const OWN: &str = "BELLCRANK_CACHE";

/// `--cache`, else `BELLCRANK_CACHE`, else where the platform keeps such things; `None` for no folder.
pub(crate) fn folder(args: &CacheArgs) -> Option<PathBuf> {
    if args.no_cache {
        return None;
    }
    args.cache.clone().or_else(|| usual(|name| std::env::var_os(name).filter(|value| !value.is_empty())))
}

fn usual(of: impl Fn(&str) -> Option<OsString>) -> Option<PathBuf> {
    let under = |name: &str, rest: &str| of(name).map(|folder| PathBuf::from(folder).join(rest));
    let platform = || {
        if cfg!(windows) {
            under("LOCALAPPDATA", "bellcrank/cache")
        } else if cfg!(target_os = "macos") {
            under("HOME", "Library/Caches/bellcrank")
        } else {
            under("XDG_CACHE_HOME", "bellcrank").or_else(|| under("HOME", ".cache/bellcrank"))
        }
    };
    of(OWN).map(PathBuf::from).or_else(platform)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_own_variable_comes_before_those_of_the_platform() {
        let all = |name: &str| Some(OsString::from(format!("/{name}")));
        assert_eq!(usual(all), Some(PathBuf::from("/BELLCRANK_CACHE")));
        let others = |name: &str| all(name).filter(|_| name != OWN);
        let usual_place = usual(others).expect("a place");
        assert!(usual_place.to_string_lossy().contains("bellcrank") && usual_place.is_absolute());
        assert_eq!(usual(|_| None), None);
    }
}
