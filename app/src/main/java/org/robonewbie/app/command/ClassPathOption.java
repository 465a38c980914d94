package org.robonewbie.app.command;

import java.io.File;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import picocli.CommandLine.Option;

/** Option {@code --class-path} of the commands that load the user's classes. */
public final class ClassPathOption {

    @Option(
            names = {"-cp", "--class-path"},
            paramLabel = "PATH",
            description = "Folders and jars with your own classes (default: the current folder).")
    private String path = ".";

    /** {@return the class path in the syntax of {@code java -cp}} */
    public String path() {
        return path;
    }

    /** {@return the folders and jars} */
    public List<Path> folders() {
        return Arrays.stream(path.split(File.pathSeparator)).map(Path::of).toList();
    }
}
