package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.jar.Attributes;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Packs the classes of this test's class path into one jar, as a release does, and starts it. */
@Tag("slow")
@Timeout(180)
class StartArchiveTest {

    @TempDir
    Path folder = Path.of("");

    @Test
    void archiveIsMadeOnceAndThenUsedAndAChangedProgramStillStarts() throws Exception {
        Path program = pack();
        Path archive = folder.resolve("program.jsa");
        makeArchive(program, archive);
        List<String> loaded = start("-Xlog:class+load", "-XX:SharedArchiveFile=" + archive, "-jar", program.toString());
        Files.setLastModifiedTime(program, FileTime.fromMillis(1_000_000));

        List<String> changed = start("-XX:SharedArchiveFile=" + archive, "-Xlog:disable", "-jar", program.toString());

        assertThat(loaded).anyMatch(line -> line.contains("org.robonewbie.app.Main source: shared objects file (top)"));
        assertThat(changed).singleElement().asString().startsWith("RoboNewbie ");
    }

    @Test
    void twoThatMakeItAtOnceMakeOneThatStartsAndTidyUpAfterOneThatWasKilled() throws Exception {
        Path program = pack();
        Path archive = folder.resolve("program.jsa");
        Files.writeString(folder.resolve("program.jsa.1.new"), "half an archive");

        Process first = beginArchive(program, archive);
        Process second = beginArchive(program, archive);
        end(first);
        end(second);

        checkFiles(archive);
        assertThat(start("-Xlog:class+load", "-XX:SharedArchiveFile=" + archive, "-jar", program.toString()))
                .anyMatch(line -> line.contains("org.robonewbie.app.Main source: shared objects file (top)"));
    }

    private void makeArchive(Path program, Path archive) throws Exception {
        end(beginArchive(program, archive));
        checkFiles(archive);
    }

    private static Process beginArchive(Path program, Path archive) throws IOException {
        List<String> command = command("-cp", program.toString(), StartTraining.class.getName(), archive.toString());
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
        builder.environment().put("ROBONEWBIE_RECORDINGS", "off");
        return builder.start();
    }

    private static void end(Process process) throws Exception {
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor()).as(said).isZero();
    }

    private void checkFiles(Path archive) {
        assertThat(archive).isRegularFile();
        assertThat(folder.toFile().list()).noneMatch(name -> name.endsWith(".new"));
    }

    private List<String> start(String... arguments) throws Exception {
        List<String> command = command(arguments);
        command.add("--version");
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        List<String> lines = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8)
                .lines()
                .toList();
        assertThat(process.waitFor()).as(lines.toString()).isZero();
        return lines;
    }

    private static List<String> command(String... arguments) {
        List<String> command = new ArrayList<>(
                List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-XX:+UseSerialGC"));
        command.addAll(List.of(arguments));
        return command;
    }

    /** Class-data sharing knows jars only, so folders of classes are packed; libraries stay the files that they are. */
    private Path pack() throws Exception {
        Path program = folder.resolve("program.jar");
        Map<String, byte[]> entries = new TreeMap<>();
        List<String> libraries = new ArrayList<>();
        for (String place : System.getProperty("java.class.path").split(File.pathSeparator, -1)) {
            if (Files.isDirectory(Path.of(place))) {
                addAll(Path.of(place), entries);
            } else if (Files.exists(Path.of(place))) {
                libraries.add(Path.of(place).toUri().toString());
            }
        }
        Manifest manifest = new Manifest();
        manifest.getMainAttributes().put(Attributes.Name.MANIFEST_VERSION, "1.0");
        manifest.getMainAttributes().put(Attributes.Name.MAIN_CLASS, Main.class.getName());
        manifest.getMainAttributes().put(Attributes.Name.CLASS_PATH, String.join(" ", libraries));
        try (JarOutputStream jar = new JarOutputStream(Files.newOutputStream(program), manifest)) {
            for (Map.Entry<String, byte[]> entry : entries.entrySet()) {
                jar.putNextEntry(new ZipEntry(entry.getKey()));
                jar.write(entry.getValue());
            }
        }
        return program;
    }

    private static void addAll(Path classes, Map<String, byte[]> entries) throws IOException {
        try (Stream<Path> files = Files.walk(classes)) {
            for (Path file : files.filter(file -> !file.equals(classes)).toList()) {
                String name = classes.relativize(file).toString().replace('\\', '/');
                boolean isFolder = Files.isDirectory(file);
                entries.putIfAbsent(isFolder ? name + "/" : name, isFolder ? new byte[0] : Files.readAllBytes(file));
            }
        }
    }
}
