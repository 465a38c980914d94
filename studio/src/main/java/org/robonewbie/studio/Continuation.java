package org.robonewbie.studio;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.studio.scene.KeptMoment;
import org.robonewbie.studio.scene.LivingWorld;

/** Lets the running simulation go on from a kept moment; puppets take the places of robots that have gone. */
final class Continuation implements LivingWorld {

    private static final long PATIENCE_NANOS = TimeUnit.SECONDS.toNanos(10);
    private static final long LOOK_NANOS = TimeUnit.MILLISECONDS.toNanos(20);

    private final Stage stage;

    Continuation(Stage stage) {
        this.stage = stage;
    }

    @Override
    public SoccerField field() {
        return stage.simulation().field();
    }

    @Override
    public WorldSnapshot now() {
        return stage.now();
    }

    @Override
    public void goOnFrom(KeptMoment moment) {
        if (!stage.simulation().hasClock()) {
            throw new IllegalStateException("A server of another process cannot be put into a kept state.");
        }
        awaitRobots(moment.state());
        stage.simulation().pause();
        stage.simulation().restore(moment.before(), moment.state());
    }

    /** Newcomers need a running clock; whoever does not come is left out. */
    private void awaitRobots(WorldSnapshot state) {
        long end = System.nanoTime() + PATIENCE_NANOS;
        if (stage.puppets().fillUp(state, stage.now()) == 0 || !stage.puppets().isOpen()) {
            return;
        }
        stage.simulation().resume();
        while (stage.puppets().fillUp(state, stage.now()) > 0 && System.nanoTime() < end) {
            LockSupport.parkNanos(LOOK_NANOS);
        }
    }
}
