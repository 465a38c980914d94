package org.robonewbie.exercises;

import java.io.File;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.robonewbie.agent.Agent;

/** Compiles start codes as students do: with what an agent may use, and without the simulator. */
final class StartCodes {

    private StartCodes() {}

    static Supplier<Agent> of(Exercise exercise) {
        return of(exercise, exercise.startCode());
    }

    static Supplier<Agent> of(Exercise exercise, String text) {
        Class<?> type = compile(exercise.className(), text);
        return () -> {
            try {
                return (Agent) type.getConstructor().newInstance();
            } catch (ReflectiveOperationException none) {
                throw new IllegalStateException(none);
            }
        };
    }

    private static Class<?> compile(String className, String text) {
        try {
            Path folder = Files.createTempDirectory("start");
            Path file = Files.writeString(folder.resolve(className + ".java"), text);
            StringWriter mistakes = new StringWriter();
            var compiler = ToolProvider.getSystemJavaCompiler();
            try (var disk = compiler.getStandardFileManager(null, null, null)) {
                List<String> options = List.of(
                        "-proc:none", "-Xlint:all,-processing", "-Werror", "-d", folder.toString(), "-cp", classPath());
                boolean correct = compiler.getTask(mistakes, disk, null, options, null, disk.getJavaFileObjects(file))
                        .call();
                if (!correct) {
                    throw new AssertionError(mistakes.toString());
                }
            }
            return new URLClassLoader(new URL[] {folder.toUri().toURL()}).loadClass(className);
        } catch (IOException unwritable) {
            throw new UncheckedIOException(unwritable);
        } catch (ClassNotFoundException none) {
            throw new IllegalStateException(none);
        }
    }

    private static String classPath() {
        return Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator, -1))
                .filter(entry -> Stream.of("robot", "protocol", "agent", "team").anyMatch(entry::contains))
                .filter(entry -> !entry.contains("simulator"))
                .collect(Collectors.joining(File.pathSeparator));
    }
}
