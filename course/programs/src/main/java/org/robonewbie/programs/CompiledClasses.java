package org.robonewbie.programs;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.URI;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import javax.tools.FileObject;
import javax.tools.ForwardingJavaFileManager;
import javax.tools.JavaFileManager;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;

/** Keeps the class files of a compilation in memory, and loads them. */
final class CompiledClasses extends ForwardingJavaFileManager<JavaFileManager> {

    private final Map<String, ByteArrayOutputStream> byteCode = new TreeMap<>();

    CompiledClasses(JavaFileManager disk) {
        super(disk);
    }

    @Override
    public JavaFileObject getJavaFileForOutput(
            Location location, String className, JavaFileObject.Kind kind, FileObject sibling) {
        return new SimpleJavaFileObject(URI.create("memory:///" + className.replace('.', '/') + ".class"), kind) {
            @Override
            public OutputStream openOutputStream() {
                ByteArrayOutputStream bytes = new ByteArrayOutputStream();
                byteCode.put(className, bytes);
                return bytes;
            }
        };
    }

    /** Writes the class files into a folder. */
    void writeTo(Path folder) throws IOException {
        for (Map.Entry<String, ByteArrayOutputStream> each : byteCode.entrySet()) {
            Path file = folder.resolve(each.getKey().replace('.', '/') + ".class");
            Files.createDirectories(Objects.requireNonNull(file.getParent()));
            Files.write(file, each.getValue().toByteArray());
        }
    }

    /** Returns the names of the classes with a main method. */
    List<String> programs(List<Path> classPath) {
        ClassLoader loader = loader(classPath);
        return byteCode.keySet().stream()
                .filter(name -> !name.contains("$") && !name.endsWith("-info"))
                .filter(name ->
                        ProgramFinder.load(name, loader).flatMap(Program::of).isPresent())
                .toList();
    }

    /** Creates a class loader for these classes and those on the class path. */
    ClassLoader loader(List<Path> classPath) {
        URLClassLoader others = ProgramFinder.loaderOf(classPath);
        return new URLClassLoader(others.getURLs(), others.getParent()) {
            @Override
            protected Class<?> findClass(String name) throws ClassNotFoundException {
                ByteArrayOutputStream bytes = byteCode.get(name);
                return bytes == null ? super.findClass(name) : defineClass(name, bytes.toByteArray(), 0, bytes.size());
            }
        };
    }
}
