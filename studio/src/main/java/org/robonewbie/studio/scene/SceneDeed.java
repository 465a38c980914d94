package org.robonewbie.studio.scene;

import java.io.IOException;
import java.nio.file.Path;

/** What was done to the file of a scene. */
final class SceneDeed {

    private SceneDeed() {}

    /** Removes a scene. */
    static Deed removed(SceneFolder folder, String scene) throws IOException {
        Path first = folder.remove(scene);
        return new Deed() {
            private Path kept = first;

            @Override
            public String name() {
                return "scene \"" + scene + "\" deleted";
            }

            @Override
            public String undo() throws IOException {
                folder.bringBack(scene, kept);
                return "";
            }

            @Override
            public String redo() throws IOException {
                kept = folder.remove(scene);
                return "";
            }
        };
    }

    /** Remembers that a scene was renamed. */
    static Deed renamed(SceneFolder folder, String from, String to) {
        return new Deed() {
            @Override
            public String name() {
                return "scene \"" + from + "\" renamed to \"" + to + "\"";
            }

            @Override
            public String undo() throws IOException {
                folder.rename(to, from);
                return "";
            }

            @Override
            public String redo() throws IOException {
                folder.rename(from, to);
                return "";
            }
        };
    }
}
