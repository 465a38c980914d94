package org.robonewbie.app.doctor;

import java.util.Optional;
import org.robonewbie.nao.file.PathEncoding;

/** Looks whether Java can read the names of all files. */
final class EncodingCheck {

    private static final String SUBJECT = "Encoding";

    private EncodingCheck() {}

    static Finding ofNames() {
        return of(PathEncoding.problem(), PathEncoding.isUnicode(), PathEncoding.name());
    }

    static Finding of(Optional<String> trouble, boolean unicode, String encoding) {
        if (trouble.isPresent()) {
            return Finding.broken(
                    SUBJECT,
                    trouble.get(),
                    "The remaining checks were skipped. Start again where the name can be read.");
        }
        return unicode
                ? Finding.well(SUBJECT, "names of files may have letters of all languages")
                : Finding.notable(
                        SUBJECT,
                        "names of files are read as " + encoding + ", which lacks umlauts and other letters",
                        "Write \"export LC_ALL=C.UTF-8\" before you start.");
    }
}
