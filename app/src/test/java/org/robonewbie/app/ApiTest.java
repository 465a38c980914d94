package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;

import japicmp.cmp.JApiCmpArchive;
import japicmp.cmp.JarArchiveComparator;
import japicmp.cmp.JarArchiveComparatorOptions;
import japicmp.model.AccessModifier;
import japicmp.model.JApiClass;
import japicmp.model.JApiCompatibility;
import japicmp.model.JApiHasChangeStatus;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.NavigableSet;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * The API: all packages that are not marked as internal. What the last release offered is still there; its classes are kept in a
 * file beside this test. A release writes the next one:
 *
 * <pre>./mvnw test -pl app -am -Dtest=ApiTest -Dsurefire.failIfNoSpecifiedTests=false -Dapi.baseline=write</pre>
 */
class ApiTest {

    private static final Path BASELINE =
            Project.ROOT.resolve("app/src/test/resources/org/robonewbie/app/api/last-release.jar");
    private static final Pattern LISTED = Pattern.compile("\\[(org\\.robonewbie[\\w.]*)\\]");

    @TempDir
    Path folder = Path.of("");

    @BeforeAll
    static void keepTheApiOfARelease() throws IOException {
        if (System.getProperty("api.baseline", "").equals("write")) {
            pack(BASELINE);
        }
    }

    @Test
    void everythingOfTheLastReleaseIsStillThere() throws IOException {
        Path today = pack(folder.resolve("today.jar"));

        List<String> broken = compare(BASELINE, today);

        assertThat(broken)
                .as(
                        "These changes break programs that students wrote for the last release. Keep the old form beside the new"
                                + " one, or mark it as deprecated until the next major version.")
                .isEmpty();
    }

    @Test
    void comparisonSeesAMissingClass() throws IOException {
        Path empty = folder.resolve("empty.jar");
        new ZipOutputStream(Files.newOutputStream(empty)).close();

        assertThat(compare(BASELINE, empty)).anyMatch(change -> change.startsWith("org.robonewbie.agent.Agent:"));
    }

    @Test
    void pageOfTheApiListsItsPackages() throws IOException {
        NavigableSet<String> listed = LISTED.matcher(Project.read(Project.ROOT.resolve("docs/api.md")))
                .results()
                .map(match -> match.group(1))
                .collect(Collectors.toCollection(TreeSet::new));

        assertThat(listed).isEqualTo(packages());
    }

    private static List<String> compare(Path old, Path today) {
        JarArchiveComparatorOptions options = new JarArchiveComparatorOptions();
        options.setAccessModifier(AccessModifier.PROTECTED);
        options.getIgnoreMissingClasses().setIgnoreAllMissingClasses(true);
        List<JApiClass> classes = new JarArchiveComparator(options)
                .compare(new JApiCmpArchive(old.toFile(), "last release"), new JApiCmpArchive(today.toFile(), "today"));
        return classes.stream()
                .filter(type -> !type.isBinaryCompatible() || !type.isSourceCompatible())
                .map(type -> type.getFullyQualifiedName() + ": " + type.getChangeStatus() + " " + changes(type))
                .toList();
    }

    private static String changes(JApiClass type) {
        return Stream.<Stream<? extends JApiCompatibility>>of(
                        type.getMethods().stream(), type.getConstructors().stream(), type.getFields().stream())
                .flatMap(members -> members)
                .filter(member -> !member.isBinaryCompatible() || !member.isSourceCompatible())
                .map(member -> ((JApiHasChangeStatus) member).getChangeStatus() + " " + member)
                .collect(Collectors.joining("; "));
    }

    /** Packs the classes of the API. */
    private static Path pack(Path jar) throws IOException {
        Files.createDirectories(jar.resolveSibling(""));
        try (ZipOutputStream out = new ZipOutputStream(Files.newOutputStream(jar))) {
            for (String name : packages()) {
                String path = name.replace('.', '/');
                for (Path classes : below("target/classes/" + path)) {
                    add(classes, path, out);
                }
            }
        }
        return jar;
    }

    private static void add(Path classes, String path, ZipOutputStream out) throws IOException {
        try (Stream<Path> files = Files.list(classes)) {
            for (Path file : files.filter(file -> file.toString().endsWith(".class"))
                    .sorted()
                    .toList()) {
                ZipEntry entry = new ZipEntry(path + "/" + file.getFileName());
                entry.setTime(0);
                out.putNextEntry(entry);
                Files.copy(file, out);
            }
        }
    }

    /** The folders of that name in all modules that have one. */
    private static List<Path> below(String path) {
        return Project.modules().stream()
                .map(module -> module.resolve(path))
                .filter(Files::isDirectory)
                .toList();
    }

    private static NavigableSet<String> packages() throws IOException {
        NavigableSet<String> packages = new TreeSet<>();
        for (Path sources : below("src/main/java")) {
            try (Stream<Path> files = Files.walk(sources)) {
                files.filter(file -> file.endsWith("package-info.java"))
                        .filter(file -> !Project.read(file).contains("<strong>Internal</strong>"))
                        .map(file ->
                                sources.relativize(file.getParent()).toString().replaceAll("[/\\\\]", "."))
                        .forEach(packages::add);
            }
        }
        return packages;
    }
}
