package org.robonewbie.site;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.net.URI;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.spi.ToolProvider;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.CRC32;

/**
 * Generates the API pages with the JDK's javadoc, for all packages whose {@code package-info.java} is not marked as internal. Pages are
 * regenerated only if sources have changed.
 */
final class ApiPages {

    /** Folder of the API pages within the site. */
    static final String FOLDER = "api";

    private static final String PACKAGE_INFO = "package-info.java";
    private static final String INTERNAL = "<strong>Internal</strong>";
    private static final Pattern SCRIPT_INSIDE =
            Pattern.compile("<script(?![^>]* src=)[^>]*>(.+?)</script>", Pattern.DOTALL);
    private static final String SOURCES_OF = "made-of.txt";

    private final Path root;
    private final String version;

    /**
     * Creates the generator.
     *
     * @param root the folder of the project
     * @param version version of the project, shown on each page
     */
    ApiPages(Path root, String version) {
        this.root = root;
        this.version = version;
    }

    /** Returns whether a file is the {@code package-info.java} of an API package. */
    static boolean isPackageOfApi(Path file) {
        try {
            return file.endsWith(PACKAGE_INFO) && !Files.readString(file).contains(INTERNAL);
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    /** Returns the address of a package's page, given the path of its {@code package-info.java}. */
    static String addressOf(String packageInfo) {
        return FOLDER + packageInfo.replaceFirst("^.*src/main/java", "").replace(PACKAGE_INFO, "package-summary.html");
    }

    /** Generates the pages unless they are up to date. */
    void build(Path site) throws IOException {
        List<Path> sources = sources();
        Path pages = site.resolve(FOLDER);
        Path note = pages.resolve(SOURCES_OF);
        String content = version + " " + fingerprint(sources);
        if (Files.isRegularFile(note) && Files.readString(note).equals(content)) {
            return;
        }
        Files.createDirectories(pages);
        run(arguments(pages, sources));
        extractScripts(pages);
        Files.writeString(note, content);
    }

    private List<Path> sources() throws IOException {
        List<Path> sources = new ArrayList<>();
        for (Path packageInfo : packages()) {
            try (Stream<Path> files = Files.list(packageInfo.resolveSibling(""))) {
                files.filter(file -> file.toString().endsWith(".java")).sorted().forEach(sources::add);
            }
        }
        return sources;
    }

    private List<Path> packages() throws IOException {
        List<Path> packages = new ArrayList<>();
        try (Stream<Path> poms = Files.find(root, 3, (file, attributes) -> file.endsWith("pom.xml"))) {
            for (Path pom : poms.sorted().toList()) {
                Path sources = pom.resolveSibling("src/main/java");
                if (Files.isDirectory(sources)) {
                    try (Stream<Path> files = Files.walk(sources)) {
                        files.filter(ApiPages::isPackageOfApi).sorted().forEach(packages::add);
                    }
                }
            }
        }
        return packages;
    }

    private static String fingerprint(List<Path> sources) throws IOException {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        for (Path source : sources) {
            all.writeBytes(Files.readAllBytes(source));
        }
        return fingerprint(all.toByteArray());
    }

    private static String fingerprint(byte[] bytes) {
        CRC32 sum = new CRC32();
        sum.update(bytes);
        return Long.toHexString(sum.getValue());
    }

    private List<String> arguments(Path pages, List<Path> sources) {
        List<String> arguments = new ArrayList<>(
                List.of("-quiet", "-Xdoclint:none", "-notimestamp", "-encoding", "UTF-8", "-charset", "UTF-8"));
        arguments.addAll(List.of("-windowtitle", "RoboNewbie " + version, "-doctitle", "RoboNewbie " + version));
        arguments.addAll(List.of("-d", pages.toString(), "-classpath", classPath()));
        sources.forEach(source -> arguments.add(source.toString()));
        return arguments;
    }

    /**
     * Returns the class path from which this class was loaded, which may differ from the JVM's; it contains the internal types that the API
     * refers to.
     */
    private static String classPath() {
        if (!(ApiPages.class.getClassLoader() instanceof URLClassLoader loader)) {
            return System.getProperty("java.class.path");
        }
        return Stream.of(loader.getURLs())
                .map(url -> Path.of(URI.create(url.toString())).toString())
                .collect(Collectors.joining(File.pathSeparator));
    }

    /** Moves inline scripts to files, because the studio's Content-Security-Policy forbids inline scripts. */
    private static void extractScripts(Path pages) throws IOException {
        List<Path> files;
        try (Stream<Path> all = Files.walk(pages)) {
            files = all.filter(file -> file.toString().endsWith(".html")).toList();
        }
        for (Path file : files) {
            Matcher script = SCRIPT_INSIDE.matcher(Files.readString(file));
            StringBuilder page = new StringBuilder();
            while (script.find()) {
                Path own = pages.resolve("script-dir")
                        .resolve(fingerprint(script.group(1).getBytes(UTF_8)) + ".js");
                Files.writeString(own, script.group(1));
                String address =
                        file.resolveSibling("").relativize(own).toString().replace('\\', '/');
                script.appendReplacement(page, "<script src=\"" + address + "\"></script>");
            }
            Files.writeString(file, script.appendTail(page));
        }
    }

    private static void run(List<String> arguments) {
        ToolProvider javadoc = ToolProvider.findFirst("javadoc")
                .orElseThrow(() -> new IllegalStateException(
                        "The API pages need javadoc, which this Java runtime lacks. Set JAVA_HOME to a JDK."));
        ByteArrayOutputStream output = new ByteArrayOutputStream();
        PrintStream printer = new PrintStream(output, true, UTF_8);
        if (javadoc.run(printer, printer, arguments.toArray(String[]::new)) != 0) {
            throw new IllegalStateException("javadoc failed:\n" + output.toString(UTF_8));
        }
    }
}
