//! A scaffolded exercise follows the schema, works, and fails `verify` with a list of what is to do.

use cagd::book::catalogue::Catalogue;
use cagd::book::exercise::{ExerciseKind, ExerciseName, Exercises};
use cagd::workbook::scaffold;
use cagd::workbook::verify::{junit, verify};

use crate::pack::Pack;

#[test]
fn every_kind_works_and_lists_what_is_to_do() {
    let place = Pack::new();
    let pack = place.path().join("scaffolded");
    let catalogue = Catalogue::load(&crate::root()).expect("the catalogue loads");
    let load = || {
        let packs = [pack.clone()];
        Exercises::load(place.path(), &packs, &catalogue).unwrap_or_else(|e| panic!("{e}"))
    };
    for kind in ExerciseKind::ALL {
        let name: ExerciseName = format!("bezier/{kind}").parse().expect("a name");
        scaffold::exercise(place.path(), Some(&pack), &name, kind, &catalogue, &load())
            .unwrap_or_else(|error| panic!("{error}"));
        let again = scaffold::exercise(place.path(), Some(&pack), &name, kind, &catalogue, &load());
        assert!(again.is_err(), "{kind} was overwritten");
    }
    let exercises = load();
    let all: Vec<_> = exercises.iter().collect();
    let verified = verify(&place.checker(), &all, true, &|_| {});
    let verified = verified.unwrap_or_else(|error| panic!("{error}"));
    // A build server sees what is left, too: a case that has failed in the suite of every kind.
    let xml = junit::xml(&verified).to_string().expect("it is written");
    let failed = xml.matches("<testcase name=\"to do\"").count();
    assert_eq!(failed, ExerciseKind::ALL.len(), "{xml}");
    for verified in verified {
        let report = verified.report;
        assert!(report.shortcomings.len() >= 5, "{report:#?}");
        for shortcoming in &report.shortcomings {
            assert_eq!(shortcoming.about, "to do", "{:#?}", report);
        }
    }
}
