fn main() {
    let out = std::env::args().nth(1).unwrap_or("/tmp/booksite".into());
    match cagd::book::build(std::path::Path::new("."), std::path::Path::new(&out)) {
        Ok(r) => println!("{r:?}"),
        Err(e) => {
            eprintln!("{e}");
            std::process::exit(1)
        }
    }
}
