package org.robonewbie.web.compiler;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import javax.tools.FileObject;
import javax.tools.JavaFileManager;
import javax.tools.JavaFileObject;
import javax.tools.StandardLocation;

/**
 * In-memory file manager of the compiler: Java's class library as the single module {@code java.base}, RoboNewbie's classes as the class
 * path, and the compiled classes as output.
 */
final class MemoryFiles implements JavaFileManager {

    private static final String BASE = "java.base";

    /** Location of the module with Java's class library. */
    private static final Location JAVA = new Location() {
        @Override
        public String getName() {
            return BASE;
        }

        @Override
        public boolean isOutputLocation() {
            return false;
        }
    };

    private final Map<String, List<MemoryFile>> java = new LinkedHashMap<>();
    private final Map<String, List<MemoryFile>> robonewbie = new LinkedHashMap<>();
    private final List<MemoryFile> made = new ArrayList<>();

    /**
     * Adds a library class.
     *
     * @param path its path with extension
     * @param content the class file
     */
    void add(String path, byte[] content) {
        boolean isRobonewbie = path.startsWith("org/robonewbie/");
        MemoryFile file = new MemoryFile(path, content);
        (isRobonewbie ? robonewbie : java)
                .computeIfAbsent(file.packageName(), name -> new ArrayList<>())
                .add(file);
    }

    /** {@return the class files compiled since the last call to {@link #forgetMade}} */
    List<MemoryFile> made() {
        return made;
    }

    /** Removes all compiled class files. */
    void forgetMade() {
        made.clear();
    }

    private Map<String, List<MemoryFile>> at(Location location) {
        if (location == JAVA) {
            return java;
        }
        return location == StandardLocation.CLASS_PATH ? robonewbie : Map.of();
    }

    @Override
    public ClassLoader getClassLoader(Location location) {
        return null;
    }

    @Override
    public Iterable<JavaFileObject> list(
            Location location, String packageName, Set<JavaFileObject.Kind> kinds, boolean recurse) {
        List<MemoryFile> found = at(location).getOrDefault(packageName, List.of());
        return kinds.contains(JavaFileObject.Kind.CLASS) ? new ArrayList<>(found) : List.of();
    }

    @Override
    public String inferBinaryName(Location location, JavaFileObject file) {
        return ((MemoryFile) file).className();
    }

    @Override
    public boolean isSameFile(FileObject one, FileObject other) {
        return one == other;
    }

    @Override
    public boolean handleOption(String current, Iterator<String> remaining) {
        return false;
    }

    @Override
    public boolean hasLocation(Location location) {
        return location == JAVA
                || location == StandardLocation.CLASS_PATH
                || location == StandardLocation.CLASS_OUTPUT
                || location == StandardLocation.SYSTEM_MODULES;
    }

    @Override
    public JavaFileObject getJavaFileForInput(Location location, String className, JavaFileObject.Kind kind) {
        String path = className.replace('.', '/') + kind.extension;
        MemoryFile wanted = new MemoryFile(path, new byte[0]);
        return at(location).getOrDefault(wanted.packageName(), List.of()).stream()
                .filter(file -> file.path().equals(path))
                .findFirst()
                .orElse(null);
    }

    @Override
    public JavaFileObject getJavaFileForOutput(
            Location location, String className, JavaFileObject.Kind kind, FileObject sibling) {
        MemoryFile file = new MemoryFile(className.replace('.', '/') + kind.extension, new byte[0]);
        made.add(file);
        return file;
    }

    @Override
    public FileObject getFileForInput(Location location, String packageName, String relativeName) {
        return null;
    }

    @Override
    public FileObject getFileForOutput(
            Location location, String packageName, String relativeName, FileObject sibling) {
        throw new UnsupportedOperationException("The compiler in the page produces class files only.");
    }

    @Override
    public Location getLocationForModule(Location location, String moduleName) {
        return location == StandardLocation.SYSTEM_MODULES && moduleName.equals(BASE) ? JAVA : null;
    }

    @Override
    public Location getLocationForModule(Location location, JavaFileObject file) {
        return null;
    }

    @Override
    public String inferModuleName(Location location) {
        return location == JAVA ? BASE : null;
    }

    @Override
    public Iterable<Set<Location>> listLocationsForModules(Location location) {
        return location == StandardLocation.SYSTEM_MODULES ? List.of(Set.of(JAVA)) : List.of();
    }

    @Override
    public boolean contains(Location location, FileObject file) {
        return false;
    }

    @Override
    public int isSupportedOption(String option) {
        return -1;
    }

    @Override
    public void flush() {}

    @Override
    public void close() {}
}
