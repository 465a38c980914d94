package org.robonewbie.studio;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Takes the pictures of the documentation that the tests of the studio's rooms show. */
@Tag("slow")
@Tag("picture")
class RoomsPictureTest {

    @Test
    void roomsGiveThePicturesOfTheDocumentation(@TempDir Path pictures) throws IOException, InterruptedException {
        PagesTest.run("picture", pictures.toString());

        try (DirectoryStream<Path> files = Files.newDirectoryStream(pictures)) {
            for (Path file : files) {
                Picture.ofDocumentation("docs/images/" + file.getFileName(), Files.readAllBytes(file));
            }
        }
    }
}
