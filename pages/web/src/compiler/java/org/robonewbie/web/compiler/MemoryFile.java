package org.robonewbie.web.compiler;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.Reader;
import java.io.Writer;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import javax.lang.model.element.Modifier;
import javax.lang.model.element.NestingKind;
import javax.tools.JavaFileObject;

/** An in-memory source or class file. */
final class MemoryFile implements JavaFileObject {

    private final String path;
    private final Kind kind;
    private byte[] content;

    /**
     * Creates a file.
     *
     * @param path its path with extension, such as {@code java/lang/String.class}
     * @param content its bytes
     */
    MemoryFile(String path, byte[] content) {
        this.path = path;
        this.content = content;
        this.kind = Arrays.stream(Kind.values())
                .filter(any -> !any.extension.isEmpty() && path.endsWith(any.extension))
                .findFirst()
                .orElse(Kind.OTHER);
    }

    /** {@return its path with extension} */
    String path() {
        return path;
    }

    /** {@return the package name, empty for the default package} */
    String packageName() {
        int end = path.lastIndexOf('/');
        return end < 0 ? "" : path.substring(0, end).replace('/', '.');
    }

    /** {@return the qualified name of its class} */
    String className() {
        return path.substring(0, path.length() - kind.extension.length()).replace('/', '.');
    }

    byte[] content() {
        return content;
    }

    /** {@return its contents as UTF-8 text} */
    String text() {
        return new String(content, StandardCharsets.UTF_8);
    }

    @Override
    public Kind getKind() {
        return kind;
    }

    /**
     * A source file may contain a public class of any name, because the class name in pasted text may differ from the
     * file name.
     */
    @Override
    public boolean isNameCompatible(String simpleName, Kind wanted) {
        String file = simpleName + wanted.extension;
        return wanted == kind && (kind == Kind.SOURCE || path.equals(file) || path.endsWith("/" + file));
    }

    @Override
    public NestingKind getNestingKind() {
        return null;
    }

    @Override
    public Modifier getAccessLevel() {
        return null;
    }

    @Override
    public URI toUri() {
        return URI.create("memory:///" + path.replace("$", "%24"));
    }

    @Override
    public String getName() {
        return path;
    }

    @Override
    public InputStream openInputStream() {
        return new ByteArrayInputStream(content);
    }

    @Override
    public OutputStream openOutputStream() {
        return new ByteArrayOutputStream() {
            @Override
            public void close() {
                content = toByteArray();
            }
        };
    }

    @Override
    public Reader openReader(boolean ignoreEncodingErrors) {
        return new InputStreamReader(openInputStream(), StandardCharsets.UTF_8);
    }

    @Override
    public CharSequence getCharContent(boolean ignoreEncodingErrors) {
        return text();
    }

    @Override
    public Writer openWriter() {
        return new OutputStreamWriter(openOutputStream(), StandardCharsets.UTF_8);
    }

    @Override
    public long getLastModified() {
        return 0;
    }

    @Override
    public boolean delete() {
        return false;
    }
}
