package org.robonewbie.app.doctor;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Tries whether files can be written into a folder. */
final class FolderCheck {

    private FolderCheck() {}

    static Finding of(String subject, Path folder) {
        try {
            Files.delete(Files.createTempFile(folder, "robonewbie", ".tmp"));
            return Finding.well(subject, folder + " can be written");
        } catch (IOException readOnly) {
            return Finding.notable(
                    subject,
                    folder + " cannot be written",
                    "Recordings and reports need another folder: change into it first, or name files there.");
        }
    }
}
