package org.robonewbie.studio.scene;

import java.io.IOException;

/** Undoable commands for saved scenes. */
final class SceneCommand {

    private SceneCommand() {}

    /** Deletes a scene and returns the command that undoes it. */
    static UndoableCommand removed(SceneStore store, String scene) throws IOException {
        SceneStore.Removed first = store.remove(scene);
        return new UndoableCommand() {
            private SceneStore.Removed kept = first;

            @Override
            public String name() {
                return "scene \"" + scene + "\" deleted";
            }

            @Override
            public String undo() throws IOException {
                kept.bringBack();
                return "";
            }

            @Override
            public String redo() throws IOException {
                kept = store.remove(scene);
                return "";
            }
        };
    }

    /** Returns the command that can undo and redo the renaming of a scene. */
    static UndoableCommand renamed(SceneStore store, String from, String to) {
        return new UndoableCommand() {
            @Override
            public String name() {
                return "scene \"" + from + "\" renamed to \"" + to + "\"";
            }

            @Override
            public String undo() throws IOException {
                store.rename(to, from);
                return "";
            }

            @Override
            public String redo() throws IOException {
                store.rename(from, to);
                return "";
            }
        };
    }
}
