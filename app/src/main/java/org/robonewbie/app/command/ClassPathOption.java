package org.robonewbie.app.command;

import java.io.File;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import picocli.CommandLine.Option;

/** The option {@code --class-path} of all commands that find people's own classes. */
public final class ClassPathOption {

    @Option(
            names = {"-cp", "--class-path"},
            paramLabel = "PATH",
            description = "Folders and jars with your own classes (default: the current folder).")
    private String path = ".";

    /** {@return the folders and jars as Java writes a class path} */
    public String path() {
        return path;
    }

    /** {@return each of the folders and jars} */
    public List<Path> folders() {
        return Arrays.stream(path.split(File.pathSeparator)).map(Path::of).toList();
    }
}
