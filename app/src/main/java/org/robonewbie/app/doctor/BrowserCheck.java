package org.robonewbie.app.doctor;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** Checks for a command that opens web pages. */
final class BrowserCheck {

    private BrowserCheck() {}

    static Finding command() {
        return command(
                System.getProperty("os.name", ""),
                Optional.ofNullable(System.getenv("PATH")).orElse(""));
    }

    /** Checks for xdg-open on Linux; Windows and macOS always have such a command. */
    static Finding command(String operatingSystem, String path) {
        String system = operatingSystem.toLowerCase(Locale.ROOT);
        if (system.contains("win") || system.contains("mac")) {
            return Finding.well("Browser", "opened by " + operatingSystem);
        }
        return Arrays.stream(path.split(File.pathSeparator))
                .map(folder -> Path.of(folder, "xdg-open"))
                .filter(Files::isExecutable)
                .findFirst()
                .map(opener -> Finding.well("Browser", "opened by " + opener))
                .orElse(Finding.notable(
                        "Browser",
                        "xdg-open not found",
                        "Copy the studio's address from the terminal into Firefox, Chrome, Edge or Safari."));
    }
}
