package org.robonewbie.studio;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;
import javax.imageio.ImageIO;

/**
 * Screenshots of tests. They are written below {@code target/pictures}. With the Maven profile {@code pictures}, those of the documentation replace the
 * files there.
 */
final class Picture {

    private static final Path KEPT = Path.of("target", "pictures");
    private static final Path PROJECT = Path.of(System.getProperty("studio.pictures", KEPT.toString()));

    private Picture() {}

    /**
     * Writes a picture of the documentation.
     *
     * @param file its path in the project, such as {@code docs/images/studio-field.png}
     */
    static void ofDocumentation(String file, byte[] png) throws IOException {
        ofDocumentation(file, ImageIO.read(new ByteArrayInputStream(png)));
    }

    /** Writes a picture of the documentation, and returns the file. */
    static Path ofDocumentation(String file, BufferedImage image) throws IOException {
        Path picture = PROJECT.resolve(file);
        Files.createDirectories(Objects.requireNonNull(picture.getParent()));
        ImageIO.write(new Palette(image).indexed(), "png", picture.toFile());
        return picture;
    }

    /** Keeps a picture for debugging. */
    static void keep(String name, byte[] png) throws IOException {
        Files.write(Files.createDirectories(KEPT).resolve(name), png);
    }
}
