package org.robonewbie.agent;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.reflect.Executable;
import java.lang.reflect.Field;
import java.lang.reflect.Member;
import java.lang.reflect.Modifier;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robonewbie.agent.log.Logger;
import org.robonewbie.agent.motion.Motions;
import org.robonewbie.agent.perception.LocalFieldView;
import org.robonewbie.agent.walk.Walk;

/**
 * What the completion of an editor shows to a student. A change here is a change of the interface that all programs of students use:
 * if it is meant, change {@code front-door.txt} too.
 */
class FrontDoorTest {

    private static final int MAX_TYPES = 12;
    private static final Path SOURCES = Path.of("src/main/java");
    private static final Pattern PACKAGE = Pattern.compile("(?:[a-z]\\w*\\.)+(?=[A-Z])");

    static List<Class<?>> types() {
        return List.of(
                Agent.class, Nao.class, Robot.class, Motions.class, Walk.class, LocalFieldView.class, Logger.class);
    }

    @Test
    void completionShowsWhatTheKeptFileLists() throws Exception {
        List<String> shown = types().stream().flatMap(FrontDoorTest::listing).toList();

        assertThat(shown).isEqualTo(kept());
    }

    @ParameterizedTest
    @MethodSource("types")
    void noSignatureNamesTheWireOrTheInside(Class<?> type) {
        assertThat(members(type).map(FrontDoorTest::generic)).isNotEmpty().noneMatch(FrontDoorTest::isInside);
    }

    @ParameterizedTest
    @MethodSource("types")
    void nothingIsThereForTheFrameworkOnly(Class<?> type) throws IOException {
        Path source = SOURCES.resolve(type.getName().replace('.', '/') + ".java");

        assertThat(Files.readString(source)).doesNotContain("the framework does this");
    }

    @Test
    void rootPackageHasFewPublicTypes() throws Exception {
        assertThat(publicTypesOfTheRoot()).contains("Agent", "Nao", "Robot").hasSizeLessThanOrEqualTo(MAX_TYPES);
    }

    private static boolean isInside(String signature) {
        return Stream.of("org.robonewbie.protocol.", "org.robonewbie.agent.cycle.", "org.robonewbie.agent.running.")
                .anyMatch(signature::contains);
    }

    private static Stream<String> listing(Class<?> type) {
        boolean inherits = type.getSuperclass() == Robot.class;
        String headline = type.getSimpleName() + (inherits ? " extends Robot" : "");
        return Stream.concat(
                Stream.of(headline),
                members(type).map(member -> "  " + shortened(member)).sorted());
    }

    /** All members that a program outside of the package may use. */
    private static Stream<Member> members(Class<?> type) {
        return Stream.of(type.getDeclaredConstructors(), type.getDeclaredFields(), type.getDeclaredMethods())
                .flatMap(members -> Arrays.stream((Member[]) members))
                .filter(member ->
                        Modifier.isPublic(member.getModifiers()) || Modifier.isProtected(member.getModifiers()))
                .filter(member -> !member.isSynthetic());
    }

    private static String shortened(Member member) {
        String owner = member.getDeclaringClass().getName() + ".";
        String text = generic(member).replace(owner + member.getName(), member.getName());
        return PACKAGE.matcher(text).replaceAll("").replaceAll("\\b(public|abstract|final) ", "");
    }

    private static String generic(Member member) {
        if (member instanceof Field field) {
            return field.toGenericString();
        }
        return ((Executable) member).toGenericString();
    }

    private static List<String> kept() throws Exception {
        return Files.readAllLines(
                Path.of(FrontDoorTest.class.getResource("front-door.txt").toURI()));
    }

    private static List<String> publicTypesOfTheRoot() throws IOException, URISyntaxException {
        Path classes = Path.of(Agent.class.getResource("Agent.class").toURI()).resolveSibling("");
        try (Stream<Path> files = Files.list(classes)) {
            return files.map(file -> file.getFileName().toString())
                    .filter(name -> name.endsWith(".class") && !name.contains("$") && !name.startsWith("package-"))
                    .map(name -> name.substring(0, name.length() - ".class".length()))
                    .filter(FrontDoorTest::isPublic)
                    .sorted()
                    .toList();
        }
    }

    private static boolean isPublic(String name) {
        try {
            return Modifier.isPublic(
                    Class.forName("org.robonewbie.agent." + name).getModifiers());
        } catch (ClassNotFoundException impossible) {
            throw new IllegalStateException(impossible);
        }
    }
}
