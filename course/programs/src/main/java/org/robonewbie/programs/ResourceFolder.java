package org.robonewbie.programs;

import java.io.IOException;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Path;
import java.util.Map;

/** Reads folders on the class path, whether on disk or in a jar. */
public final class ResourceFolder {

    private ResourceFolder() {}

    /** Reads the files in an open folder. */
    public interface Reader {

        /**
         * Reads the files.
         *
         * @param folder the folder, which is open during this call
         * @throws IOException if a file cannot be read
         */
        void read(Path folder) throws IOException;
    }

    /**
     * Opens a folder, passes it to the reader and closes it.
     *
     * @param place URL of the folder, as returned by the class loader
     * @param name its path on the class path, separated by slashes
     * @param reader receives the folder
     * @throws IOException if it cannot be read
     */
    public static void read(URL place, String name, Reader reader) throws IOException {
        URI address = addressOf(place);
        if (address.getScheme().equals("jar")) {
            try (FileSystem jar = FileSystems.newFileSystem(address, Map.of())) {
                reader.read(jar.getPath(name));
            }
        } else {
            reader.read(Path.of(address));
        }
    }

    private static URI addressOf(URL place) {
        try {
            return place.toURI();
        } catch (URISyntaxException impossible) {
            throw new IllegalStateException("The class path cannot be read", impossible);
        }
    }
}
