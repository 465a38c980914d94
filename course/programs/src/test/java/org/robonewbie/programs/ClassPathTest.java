package org.robonewbie.programs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.File;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.jar.Attributes;
import java.util.jar.JarFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ClassPathTest {

    @TempDir
    Path folder = Path.of("");

    @Test
    void ordinaryPlacesAreJoined() {
        ClassPath classPath = new ClassPath(List.of(folder.resolve("a b"), folder.resolve("ü%20.jar")));

        assertThat(classPath.option())
                .isEqualTo(folder.resolve("a b") + File.pathSeparator + folder.resolve("ü%20.jar"));
    }

    @DisabledOnOs(OS.WINDOWS)
    @ParameterizedTest
    @ValueSource(strings = {"a:b", "x\uD83D\uDCBBy", "100% : \uD83E\uDD16 #"})
    void javaFindsClassesInPlacesThatNoOptionCanName(String name) throws Exception {
        assumeThat(System.getProperty("sun.jnu.encoding")).isEqualTo("UTF-8");
        Path place = Files.createDirectories(folder.resolve(name));
        Files.writeString(place.resolve("greeting.txt"), "there");
        ClassPath classPath =
                new ClassPath(List.of(place)).with(ClassPath.ofThisProgram().places());

        Process process = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-XX:TieredStopAtLevel=1",
                        "-cp",
                        classPath.option() + File.pathSeparator + System.getProperty("java.class.path"),
                        Finder.class.getName())
                .redirectErrorStream(true)
                .start();

        assertThat(process.getInputStream()).hasBinaryContent("there".getBytes(StandardCharsets.UTF_8));
        assertThat(process.waitFor()).isZero();
    }

    @DisabledOnOs(OS.WINDOWS)
    @Test
    void sameClassPathHasOneJarWhichNamesAllPlaces() throws Exception {
        ClassPath classPath = new ClassPath(List.of(folder.resolve("a:b.jar"), folder.resolve("c.jar")));

        String option = classPath.option();

        assertThat(new ClassPath(classPath.places()).option()).isEqualTo(option);
        try (JarFile jar = new JarFile(option)) {
            assertThat(jar.getManifest().getMainAttributes().getValue(Attributes.Name.CLASS_PATH))
                    .contains("/a:b.jar ", "/c.jar");
        }
    }

    @Test
    void obstacleIsTheCharacterItself() {
        assertThat(ClassPath.obstacle(Path.of("x\uD83D\uDCBBy"))).contains("\uD83D\uDCBB");
        assertThat(ClassPath.obstacle(Path.of("Übung 100% & +"))).isEmpty();
    }

    /** Prints a file of its class path. */
    public static final class Finder {

        private Finder() {}

        /** Prints the file. */
        public static void main(String[] args) throws Exception {
            try (var file = Objects.requireNonNull(Finder.class.getResourceAsStream("/greeting.txt"))) {
                file.transferTo(System.out);
            }
        }
    }
}
