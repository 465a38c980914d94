package org.robonewbie.app.doctor;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Checks whether a folder is writable. */
final class FolderCheck {

    private FolderCheck() {}

    static Finding of(String subject, Path folder) {
        try {
            Files.delete(Files.createTempFile(folder, "robonewbie", ".tmp"));
            return Finding.well(subject, folder + " is writable");
        } catch (IOException readOnly) {
            return Finding.notable(
                    subject,
                    folder + " is not writable",
                    "Recordings and reports need a writable folder. Change to such a folder, or pass paths inside one.");
        }
    }
}
