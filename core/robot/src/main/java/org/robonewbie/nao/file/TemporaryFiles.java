package org.robonewbie.nao.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Creates files and folders in the system's folder for temporary files. */
public final class TemporaryFiles {

    private TemporaryFiles() {}

    /**
     * Creates an empty folder.
     *
     * @param prefix start of the folder's name
     * @return the folder
     * @throws IOException if the folder cannot be created; the message says what to do
     */
    public static Path folder(String prefix) throws IOException {
        try {
            return Files.createTempDirectory(prefix);
        } catch (IOException impossible) {
            throw explained(impossible);
        }
    }

    /**
     * Creates an empty file.
     *
     * @param prefix start of the file's name
     * @param suffix end of the file's name
     * @return the file
     * @throws IOException if the file cannot be created; the message says what to do
     */
    public static Path file(String prefix, String suffix) throws IOException {
        try {
            return Files.createTempFile(prefix, suffix);
        } catch (IOException impossible) {
            throw explained(impossible);
        }
    }

    /** {@return a sentence with advice on choosing another folder} */
    public static String howToChoose() {
        return "To use another folder, set the environment variable JAVA_TOOL_OPTIONS=-Djava.io.tmpdir=FOLDER.";
    }

    private static IOException explained(IOException impossible) {
        Path folder = Path.of(System.getProperty("java.io.tmpdir", "."));
        String found = Files.isDirectory(folder) ? "cannot be written to" : "does not exist";
        return new IOException(
                "The system's folder for temporary files, " + folder + ", " + found + " (" + impossible.getMessage()
                        + "). " + howToChoose(),
                impossible);
    }
}
