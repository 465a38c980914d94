import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.lang.module.ModuleDescriptor;
import java.lang.reflect.Executable;
import java.lang.reflect.Modifier;
import java.net.URI;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robonewbie.web.compiling.ProgramLibrary;

/**
 * Packs the class files that the compiler in the page needs: the Java classes that programs may use, their dependencies,
 * and RoboNewbie's classes. Format: number of classes, then the path, size in bytes, and contents of each.
 *
 * <p>Usage: {@code java -cp CLASS_PATH PackLibrary.java FILE MISSING}. The second file receives the names of Java
 * classes that are not available in the page: one line per package, with the package name followed by the class names.
 */
final class PackLibrary {

    /** Classes that javac requires. */
    private static final String[] ALSO = {
        "java.lang.Override", "java.lang.Deprecated", "java.lang.SuppressWarnings", "java.lang.FunctionalInterface",
        "java.lang.SafeVarargs", "java.lang.Void", "java.lang.annotation.Annotation", "java.lang.annotation.Target",
        "java.lang.annotation.Retention", "java.lang.annotation.RetentionPolicy", "java.lang.annotation.ElementType",
        "java.lang.annotation.Repeatable", "java.lang.annotation.Native", "java.lang.annotation.Documented",
        "java.lang.annotation.Inherited", "java.lang.ClassLoader", "java.lang.Module", "java.lang.Package",
        "java.lang.ClassNotFoundException", "java.lang.NoClassDefFoundError", "java.lang.ReflectiveOperationException",
        "java.lang.invoke.LambdaMetafactory", "java.lang.invoke.StringConcatFactory", "java.lang.invoke.MethodHandles$Lookup",
        "java.lang.invoke.MethodHandles", "java.lang.invoke.MethodHandle", "java.lang.invoke.MethodType",
        "java.lang.invoke.CallSite", "java.lang.invoke.VarHandle", "java.lang.invoke.TypeDescriptor",
        "java.lang.Enum$EnumDesc", "java.lang.runtime.ObjectMethods", "java.lang.LinkageError",
        "java.lang.IncompatibleClassChangeError"
    };

    /** Modules whose classes students may try to use. */
    private static final List<String> MODULES =
            List.of("java.base", "java.desktop", "java.logging", "java.net.http", "java.prefs", "java.sql", "java.xml");

    private PackLibrary() {}

    public static void main(String[] args) throws IOException, ClassNotFoundException {
        Map<String, byte[]> classes = new TreeMap<>();
        Path base = FileSystems.getFileSystem(URI.create("jrt:/")).getPath("modules", "java.base");
        for (String name : javaClasses()) {
            String file = name.replace('.', '/') + ".class";
            classes.put(file, Files.readAllBytes(base.resolve(file)));
        }
        classes.put("module-info.class", Files.readAllBytes(base.resolve("module-info.class")));
        addRobonewbie(classes);
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (DataOutputStream output = new DataOutputStream(packed)) {
            output.writeInt(classes.size());
            for (Map.Entry<String, byte[]> one : classes.entrySet()) {
                output.writeUTF(one.getKey());
                output.writeInt(one.getValue().length);
                output.write(one.getValue());
            }
        }
        Path file = Path.of(args[0]);
        Files.createDirectories(file.getParent());
        Files.write(file, packed.toByteArray());
        Files.writeString(Path.of(args[1]), missing(classes.keySet()));
        System.out.println(classes.size() + " classes, " + packed.size() + " bytes");
    }

    /**
     * Lists Java's public classes that are missing from the page, except those with the same simple name as an
     * available class.
     */
    private static String missing(Set<String> files) throws IOException, ClassNotFoundException {
        Set<String> known = files.stream()
                .map(file -> file.substring(file.lastIndexOf('/') + 1).replace(".class", ""))
                .collect(Collectors.toCollection(TreeSet::new));
        StringBuilder lines = new StringBuilder();
        for (String module : MODULES) {
            for (ModuleDescriptor.Exports exported :
                    new TreeSet<>(ModuleLayer.boot().findModule(module).orElseThrow().getDescriptor().exports())) {
                if (exported.isQualified() || !exported.source().startsWith("java")) {
                    continue;
                }
                List<String> names = new ArrayList<>();
                Path folder = Path.of(URI.create("jrt:/" + module + "/" + exported.source().replace('.', '/')));
                try (Stream<Path> all = Files.list(folder)) {
                    for (Path file : all.filter(each -> each.toString().endsWith(".class")).sorted().toList()) {
                        String name = file.getFileName().toString().replace(".class", "");
                        if (!name.contains("$") && !name.equals("package-info") && isPublic(exported.source() + "." + name)
                                && known.add(name)) {
                            names.add(name);
                        }
                    }
                }
                if (!names.isEmpty()) {
                    lines.append(exported.source()).append(' ').append(String.join(" ", names)).append('\n');
                }
            }
        }
        return lines.toString();
    }

    private static boolean isPublic(String name) throws ClassNotFoundException {
        return Modifier.isPublic(
                Class.forName(name, false, ClassLoader.getPlatformClassLoader()).getModifiers());
    }

    /** Returns the allowed classes, their supertypes, and the types in their signatures. */
    private static TreeSet<String> javaClasses() throws ClassNotFoundException, IOException {
        TreeSet<String> names = new TreeSet<>();
        for (String name : ProgramLibrary.javaClasses()) {
            Class<?> type = Class.forName(name, false, null);
            addWithAbove(type, names);
            for (Executable method : Stream.<Executable>concat(
                            Stream.of(type.getDeclaredMethods()), Stream.of(type.getDeclaredConstructors()))
                    .filter(one -> Modifier.isPublic(one.getModifiers()) || Modifier.isProtected(one.getModifiers()))
                    .toList()) {
                for (Class<?> parameter : method.getParameterTypes()) {
                    addWithAbove(parameter, names);
                }
                for (Class<?> thrown : method.getExceptionTypes()) {
                    addWithAbove(thrown, names);
                }
                if (method instanceof java.lang.reflect.Method plain) {
                    addWithAbove(plain.getReturnType(), names);
                }
            }
        }
        for (String name : ALSO) {
            addWithAbove(Class.forName(name, false, null), names);
        }
        try (Stream<Path> functions = Files.list(Path.of(URI.create("jrt:/java.base/java/util/function")))) {
            functions.map(file -> file.getFileName().toString())
                    .filter(name -> !name.contains("package-info"))
                    .forEach(name -> names.add("java.util.function." + name.replace(".class", "")));
        }
        return names;
    }

    private static void addWithAbove(Class<?> type, TreeSet<String> names) {
        Class<?> plain = type;
        while (plain.isArray()) {
            plain = plain.getComponentType();
        }
        if (plain.isPrimitive() || !names.add(plain.getName())) {
            return;
        }
        if (plain.getEnclosingClass() != null) {
            addWithAbove(plain.getEnclosingClass(), names);
        }
        if (plain.getSuperclass() != null) {
            addWithAbove(plain.getSuperclass(), names);
        }
        for (Class<?> above : plain.getInterfaces()) {
            addWithAbove(above, names);
        }
    }

    private static void addRobonewbie(Map<String, byte[]> classes) throws IOException {
        for (String place : System.getProperty("java.class.path").split(File.pathSeparator)) {
            Path path = Path.of(place);
            if (place.contains("robonewbie") || place.endsWith("classes")) {
                if (Files.isDirectory(path)) {
                    addFolder(path, classes);
                } else {
                    try (FileSystem jar = FileSystems.newFileSystem(path)) {
                        addFolder(jar.getPath("/"), classes);
                    }
                }
            }
        }
    }

    private static void addFolder(Path folder, Map<String, byte[]> classes) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                String name = folder.relativize(file).toString().replace('\\', '/');
                boolean isWanted = name.endsWith(".class")
                        && ProgramLibrary.has(name.replace(".class", "").replace('/', '.').replaceAll("\\$.*", ""));
                boolean isAgentCycle = name.startsWith("org/robonewbie/protocol/") && name.endsWith(".class")
                        || name.startsWith("org/robonewbie/nao/") && name.endsWith(".class");
                if (isWanted || isAgentCycle) {
                    try (InputStream input = Files.newInputStream(file)) {
                        classes.putIfAbsent(name, input.readAllBytes());
                    }
                }
            }
        }
    }
}
