//! Warnings of a run: the same one at many rows is told once, with where it began and ended.

/// Warnings by text.
#[derive(Debug, Default)]
pub(super) struct Notes {
    all: Vec<Note>,
}

#[derive(Debug)]
struct Note {
    message: String,
    first: String,
    last: String,
    count: usize,
}

impl Notes {
    /// Adds a warning that holds at a place.
    pub(super) fn add(&mut self, message: &str, place: &dyn Fn() -> String) {
        match self.all.iter_mut().find(|note| note.message == message) {
            Some(note) => {
                note.last = place();
                note.count += 1;
            }
            None => {
                let first = place();
                self.all.push(Note { message: message.to_owned(), last: first.clone(), first, count: 1 });
            }
        }
    }

    /// One sentence for each.
    pub(super) fn sentences(self) -> Vec<String> {
        self.all.into_iter().map(Note::sentence).collect()
    }
}

impl Note {
    fn sentence(self) -> String {
        match self.count {
            1 => format!("at {}: {}", self.first, self.message),
            2 => format!("at {} and {}: {}", self.first, self.last, self.message),
            n => format!("at {n} rows from {} to {}: {}", self.first, self.last, self.message),
        }
    }
}
