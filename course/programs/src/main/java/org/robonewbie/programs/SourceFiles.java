package org.robonewbie.programs;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import javax.tools.FileObject;
import javax.tools.ForwardingJavaFileManager;
import javax.tools.ForwardingJavaFileObject;
import javax.tools.JavaFileManager;
import javax.tools.JavaFileObject;
import javax.tools.StandardJavaFileManager;
import org.robonewbie.nao.file.TextFile;

/**
 * File manager that uses {@link TextFile} to decode the Java files to compile and those on the source path, regardless
 * of the system's default encoding.
 */
public final class SourceFiles extends ForwardingJavaFileManager<StandardJavaFileManager> {

    /**
     * Creates a file manager.
     *
     * @param disk the compiler's standard file manager
     */
    public SourceFiles(StandardJavaFileManager disk) {
        super(disk);
    }

    /**
     * Wraps files for the compiler.
     *
     * @param files Java files
     * @return file objects
     */
    public List<JavaFileObject> of(List<Path> files) {
        return decoded(fileManager.getJavaFileObjectsFromPaths(files));
    }

    @Override
    public Iterable<JavaFileObject> list(
            Location location, String packageName, Set<JavaFileObject.Kind> kinds, boolean recurse) throws IOException {
        Iterable<JavaFileObject> files = super.list(location, packageName, kinds, recurse);
        return kinds.contains(JavaFileObject.Kind.SOURCE) ? decoded(files) : files;
    }

    @Override
    public String inferBinaryName(Location location, JavaFileObject file) {
        return super.inferBinaryName(location, file instanceof Decoded decoded ? decoded.onDisk() : file);
    }

    @Override
    public boolean isSameFile(FileObject file, FileObject other) {
        return super.isSameFile(onDisk(file), onDisk(other));
    }

    @Override
    public boolean contains(JavaFileManager.Location location, FileObject file) throws IOException {
        return super.contains(location, onDisk(file));
    }

    private static FileObject onDisk(FileObject file) {
        return file instanceof Decoded decoded ? decoded.onDisk() : file;
    }

    private List<JavaFileObject> decoded(Iterable<? extends JavaFileObject> files) {
        List<JavaFileObject> decoded = new ArrayList<>();
        for (JavaFileObject file : files) {
            decoded.add(
                    file.getKind() == JavaFileObject.Kind.SOURCE ? new Decoded(file, fileManager.asPath(file)) : file);
        }
        return decoded;
    }

    private static final class Decoded extends ForwardingJavaFileObject<JavaFileObject> {

        private final Path path;

        Decoded(JavaFileObject file, Path path) {
            super(file);
            this.path = path;
        }

        JavaFileObject onDisk() {
            return fileObject;
        }

        @Override
        public CharSequence getCharContent(boolean ignoreEncodingErrors) throws IOException {
            return TextFile.readAndNote(path).content();
        }
    }
}
