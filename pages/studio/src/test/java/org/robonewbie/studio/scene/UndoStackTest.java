package org.robonewbie.studio.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class UndoStackTest {

    private final UndoStack history = new UndoStack();
    private final List<String> happened = new ArrayList<>();

    private UndoableCommand command(String name) {
        return new UndoableCommand() {
            @Override
            public String name() {
                return name;
            }

            @Override
            public String undo() {
                happened.add("undo " + name);
                return "";
            }

            @Override
            public String redo() {
                happened.add("redo " + name);
                return "Speeds are estimated.";
            }
        };
    }

    @Test
    void newestCommandIsUndoneFirstAndRedone() throws IOException {
        history.add(command("ball moved"));
        history.add(command("reset"));

        assertThat(history.undo()).isEqualTo("Undone: reset.");
        assertThat(history.undo()).isEqualTo("Undone: ball moved.");
        assertThat(history.undo()).isEqualTo("There is nothing to undo.");
        assertThat(history.redo()).isEqualTo("Redone: ball moved. Speeds are estimated.");

        assertThat(happened).containsExactly("undo reset", "undo ball moved", "redo ball moved");
        assertThat(history.nextUndo()).isEqualTo("ball moved");
        assertThat(history.nextRedo()).isEqualTo("reset");
    }

    @Test
    void newCommandClearsTheRedoStack() throws IOException {
        history.add(command("ball moved"));
        history.undo();

        history.add(command("reset"));

        assertThat(history.nextRedo()).isEmpty();
        assertThat(history.redo()).isEqualTo("There is nothing to redo.");
    }

    @Test
    void stackIsBounded() throws IOException {
        for (int number = 0; number < 2 * UndoStack.CAPACITY; number++) {
            history.add(command("change " + number));
        }

        int undone = 0;
        while (!history.nextUndo().isEmpty()) {
            history.undo();
            undone++;
        }

        assertThat(undone).isEqualTo(UndoStack.CAPACITY);
    }

    @Test
    void commandThatCannotBeUndoneStaysDone() {
        history.add(new UndoableCommand() {
            @Override
            public String name() {
                return "scene deleted";
            }

            @Override
            public String undo() throws IOException {
                throw new IOException("the disk is full");
            }

            @Override
            public String redo() {
                return "";
            }
        });

        assertThatThrownBy(history::undo).hasMessage("the disk is full");
        assertThat(history.nextUndo()).isEqualTo("scene deleted");
    }
}
