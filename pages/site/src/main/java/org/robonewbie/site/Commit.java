package org.robonewbie.site;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;

/** Identifies the commit from which a project folder is built. */
final class Commit {

    /** File whose contents {@code git archive} replaces with the full commit id; see {@code .gitattributes}. */
    private static final String OF_ARCHIVE = "release/commit.txt";

    private static final int DIGITS = 8;

    private Commit() {}

    /**
     * Returns the first digits of the commit's id, followed by {@code -modified} if a file differs from the commit.
     *
     * @param root folder of the project
     * @return the id; empty if the folder is neither a working tree nor an archive of a commit
     */
    static String of(Path root) throws IOException {
        ProcessBuilder git = new ProcessBuilder(
                        "git", "describe", "--always", "--exclude=*", "--abbrev=" + DIGITS, "--dirty=-modified")
                .directory(root.toFile())
                .redirectError(ProcessBuilder.Redirect.DISCARD);
        // The project may be inside another project's repository.
        git.environment().put("GIT_CEILING_DIRECTORIES", Objects.toString(root.getParent()));
        try {
            Process process = git.start();
            String id = new String(process.getInputStream().readAllBytes(), UTF_8).strip();
            return id.isEmpty() ? ofArchive(root) : id;
        } catch (IOException noGit) {
            return ofArchive(root);
        }
    }

    private static String ofArchive(Path root) throws IOException {
        Path file = root.resolve(OF_ARCHIVE);
        String id = Files.isRegularFile(file) ? Files.readString(file).strip() : "";
        return id.matches("\\p{XDigit}{40}") ? id.substring(0, DIGITS) : "";
    }
}
