package org.robonewbie.nao.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Makes files and folders in the system's folder for temporary files. */
public final class TemporaryFiles {

    private TemporaryFiles() {}

    /**
     * Makes an empty folder.
     *
     * @param prefix how its name begins
     * @return the folder
     * @throws IOException if that is impossible; the message says what to do
     */
    public static Path folder(String prefix) throws IOException {
        try {
            return Files.createTempDirectory(prefix);
        } catch (IOException impossible) {
            throw explained(impossible);
        }
    }

    /**
     * Makes an empty file.
     *
     * @param prefix how its name begins
     * @param suffix how it ends
     * @return the file
     * @throws IOException if that is impossible; the message says what to do
     */
    public static Path file(String prefix, String suffix) throws IOException {
        try {
            return Files.createTempFile(prefix, suffix);
        } catch (IOException impossible) {
            throw explained(impossible);
        }
    }

    /** {@return how another folder for temporary files is named} */
    public static String howToChoose() {
        return "Name another folder by the environment variable JAVA_TOOL_OPTIONS=-Djava.io.tmpdir=FOLDER.";
    }

    private static IOException explained(IOException impossible) {
        Path folder = Path.of(System.getProperty("java.io.tmpdir", "."));
        String found = Files.isDirectory(folder) ? "cannot be written" : "does not exist";
        return new IOException(
                "The system's folder for temporary files, " + folder + ", " + found + " (" + impossible.getMessage()
                        + "). " + howToChoose(),
                impossible);
    }
}
