package org.robonewbie.studio.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Path;
import java.util.Objects;
import org.junit.jupiter.api.Test;

/** A scene saved by the studio of the first preview of version 2.0.0 (commit 5fc1aa37) from an empty pitch. */
class FormerScenesTest {

    @Test
    void sceneIsListedAndLoadedToTheBit() throws IOException, URISyntaxException {
        SceneFolder folder = new SceneFolder(
                Path.of(Objects.requireNonNull(FormerScenesTest.class.getResource("/former-files/scenes"))
                        .toURI()));

        Checkpoint moment = folder.read("empty-pitch").checkpoint().orElseThrow();

        assertThat(folder.names()).containsExactly("empty-pitch");
        assertThat(moment.state().robots()).isEmpty();
        assertThat(moment.exact()).isPresent();
    }
}
