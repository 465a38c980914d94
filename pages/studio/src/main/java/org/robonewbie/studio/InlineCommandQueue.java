package org.robonewbie.studio;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;

/** Does everything at once, where simulation, robots and people share one thread, such as in a page of the browser. */
final class InlineCommandQueue implements CommandQueue {

    /** Robots enter while they are looked for; one that has to wait for another team comes at the second look. */
    private static final int MOST_LOOKS = 10;

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
        for (int look = 0; look < MOST_LOOKS && !holds; look++) {
            holds = condition.getAsBoolean();
        }
    }

    @Override
    public void close() {
        // nothing is under way
    }
}
