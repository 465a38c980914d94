package org.robonewbie.pagejvm;

import java.util.Map;

/** Class loader that prefers in-memory classes to those of its parent. */
public final class MemoryLoader extends ClassLoader {

    private final Map<String, byte[]> classes;

    /**
     * Creates a class loader.
     *
     * @param classes class files by name
     */
    public MemoryLoader(Map<String, byte[]> classes) {
        super(MemoryLoader.class.getClassLoader());
        this.classes = classes;
    }

    @Override
    protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
        byte[] bytes = classes.get(name);
        if (bytes == null) {
            return super.loadClass(name, resolve);
        }
        Class<?> loaded = findLoadedClass(name);
        return loaded == null ? defineClass(name, bytes, 0, bytes.length) : loaded;
    }
}
