package org.robonewbie.studio;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;
import javax.imageio.ImageIO;

/**
 * Screenshots of the documentation. They are written below {@code target/pictures}; with the Maven profile {@code pictures}, they replace
 * the files of the documentation.
 */
final class Picture {

    private static final Path PROJECT = Path.of(System.getProperty("studio.pictures", "target/pictures"));

    private Picture() {}

    /**
     * Writes a picture.
     *
     * @param file its path in the project, such as {@code docs/images/studio-field.png}
     */
    static void ofDocumentation(String file, byte[] png) throws IOException {
        BufferedImage image = ImageIO.read(new ByteArrayInputStream(png));
        Path picture = PROJECT.resolve(file);
        Files.createDirectories(Objects.requireNonNull(picture.getParent()));
        ImageIO.write(new Palette(image).indexed(), "png", picture.toFile());
    }
}
