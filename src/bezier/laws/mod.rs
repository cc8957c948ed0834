//! One law per theorem, lemma, corollary and algorithm of the chapter, in the sections of its text.
