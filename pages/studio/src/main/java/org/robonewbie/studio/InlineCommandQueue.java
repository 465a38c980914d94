package org.robonewbie.studio;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * Command queue that runs each command immediately. Used in pages in which the simulation, the robots and the user's
 * commands share one thread.
 */
final class InlineCommandQueue implements CommandQueue {

    /**
     * Maximum number of evaluations of the condition in {@link #await}. Each evaluation lets robots join; a robot that must
     * wait for the other team joins during the second evaluation.
     */
    private static final int MAX_EVALUATIONS = 10;

    @Override
    public void later(Runnable work) {
        work.run();
    }

    @Override
    public <T> T result(Supplier<T> work) {
        return work.get();
    }

    @Override
    public <T> T answer(T none, Consumer<Consumer<T>> request) {
        List<T> answers = new ArrayList<>(List.of(none));
        request.accept(answers::add);
        return answers.get(answers.size() - 1);
    }

    @Override
    public void await(BooleanSupplier condition) {
        boolean holds = false;
        for (int look = 0; look < MAX_EVALUATIONS && !holds; look++) {
            holds = condition.getAsBoolean();
        }
    }

    @Override
    public void close() {
        // nothing is pending
    }
}
