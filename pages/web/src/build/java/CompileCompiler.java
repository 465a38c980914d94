import java.io.File;
import java.io.IOException;
import java.net.URI;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.ToolProvider;

/**
 * Compiles javac to WebAssembly: copies it from the running JDK, compiles the page's entry points and the studio's code completion, and
 * calls {@code CompileToWebAssembly}. Parts that need files are stubbed out.
 *
 * <p>Usage: {@code java -cp CLASS_PATH CompileCompiler.java FOLDER_OF_SOURCES WORK_FOLDER FILE}
 */
final class CompileCompiler {

    private static final List<String> MODULES = List.of("jdk.compiler", "java.compiler", "jdk.internal.opt");

    /** Code completion and hints that the page shares with the studio. */
    private static final List<String> SHARED = List.of(
            "course/programs/src/main/java/org/robonewbie/programs/completion",
            "course/programs/src/main/java/org/robonewbie/programs/hint",
            "core/robot/src/main/java/org/robonewbie/nao/text/ConfusableCharacter.java",
            "core/robot/src/main/java/org/robonewbie/nao/text/Spelling.java");

    private static final String MAIN_CLASS = "org.robonewbie.web.compiler.CompilerInPage";

    private CompileCompiler() {}

    public static void main(String[] args) throws IOException, InterruptedException {
        Path sources = Path.of(args[0]);
        Path work = Path.of(args[1]);
        Path javac = work.resolve("javac");
        Path classes = Files.createDirectories(work.resolve("classes"));
        Path file = Path.of(args[2]);
        Files.createDirectories(file.getParent());
        FileSystem jdk = FileSystems.getFileSystem(URI.create("jrt:/"));
        for (String module : MODULES) {
            copy(jdk.getPath("modules", module), javac);
        }
        copy(sources.resolveSibling("resources"), classes);
        String libraries = javac + File.pathSeparator + withoutRobonewbie(System.getProperty("java.class.path"));
        List<Path> ours = new ArrayList<>(List.of(sources));
        SHARED.forEach(place ->
                ours.add(sources.resolve("../../../../..").resolve(place).normalize()));
        compile(ours, classes, libraries);
        Path compileToWebAssembly =
                sources.resolve("../../build/java/CompileToWebAssembly.java").normalize();
        int exitCode = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-Xmx3g",
                        "-Xss8m",
                        "-XX:+UseSerialGC",
                        "-classpath",
                        classes + File.pathSeparator + libraries,
                        compileToWebAssembly.toString(),
                        MAIN_CLASS,
                        file.toString())
                .inheritIO()
                .start()
                .waitFor();
        System.exit(exitCode);
    }

    /** Removes RoboNewbie's classes, because TeaVM would apply the policies that belong to the page's other module. */
    private static String withoutRobonewbie(String classPath) {
        return Arrays.stream(classPath.split(File.pathSeparator))
                .filter(place -> !place.endsWith("classes") && !place.contains("robonewbie-"))
                .collect(Collectors.joining(File.pathSeparator));
    }

    private static void compile(List<Path> folders, Path classes, String libraries) throws IOException {
        List<String> arguments = new ArrayList<>(List.of(
                "--limit-modules", "java.base", "-proc:none", "-d", classes.toString(), "-classpath", libraries));
        for (Path folder : folders) {
            try (Stream<Path> files = Files.walk(folder)) {
                files.filter(file -> file.toString().endsWith(".java")).forEach(file -> arguments.add(file.toString()));
            }
        }
        int exitCode = ToolProvider.getSystemJavaCompiler().run(null, null, null, arguments.toArray(String[]::new));
        if (exitCode != 0) {
            System.exit(exitCode);
        }
    }

    private static void copy(Path from, Path to) throws IOException {
        try (Stream<Path> files = Files.walk(from)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                String name = from.relativize(file).toString();
                if (!name.equals("module-info.class")) {
                    Path copy = to.resolve(name);
                    Files.createDirectories(copy.getParent());
                    Files.copy(file, copy, StandardCopyOption.REPLACE_EXISTING);
                }
            }
        }
    }
}
