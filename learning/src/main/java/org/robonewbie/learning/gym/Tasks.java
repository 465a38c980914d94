package org.robonewbie.learning.gym;

import java.util.List;
import java.util.stream.Collectors;

/** All tasks by their names. */
final class Tasks {

    private static final List<Task> ALL = List.of(new StandTask(), new WalkTask(), new KickTask(), new ReachTask());

    private Tasks() {}

    /**
     * Looks up a task.
     *
     * @throws IllegalArgumentException if there is none of this name; the message lists all
     */
    static Task named(String name) {
        return ALL.stream()
                .filter(task -> task.name().equals(name))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("There is no task \"" + name + "\". The tasks are: "
                        + ALL.stream().map(Task::name).collect(Collectors.joining(", ")) + "."));
    }
}
