package org.robonewbie.app.doctor;

import java.util.Optional;
import org.robonewbie.nao.file.PathEncoding;

/** Checks the encoding of file names. */
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
                    "The remaining checks were skipped. Move to a folder whose name can be read, and start again.");
        }
        return unicode
                ? Finding.well(SUBJECT, "file names may contain letters from all languages")
                : Finding.notable(
                        SUBJECT,
                        "file names are decoded as " + encoding + ", which lacks umlauts and other letters",
                        "Run \"export LC_ALL=C.UTF-8\" before you start.");
    }
}
