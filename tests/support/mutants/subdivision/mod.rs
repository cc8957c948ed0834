//! Wrong subdivision, in the sections of the chapter.
