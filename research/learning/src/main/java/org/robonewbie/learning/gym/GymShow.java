package org.robonewbie.learning.gym;

import java.io.IOException;
import java.net.URI;
import org.robonewbie.simulator.embedded.RedirectPage;
import org.robonewbie.simulator.embedded.Viewer;
import org.robonewbie.trial.watch.WatchedTrial;

/** One environment under the eyes of people: it runs in real time, and they can stop its clock. */
final class GymShow implements AutoCloseable {

    private final GymEnvironment environment;
    private final WatchedTrial watched;
    private final Viewer.View view;

    private GymShow(GymEnvironment environment, WatchedTrial watched, Viewer.View view) {
        this.environment = environment;
        this.watched = watched;
        this.view = view;
    }

    static GymShow open(GymEnvironment environment, GymStage stage) throws IOException {
        WatchedTrial watched = new WatchedTrial();
        Viewer.View view = stage.show(watched);
        environment.setAudience(watched);
        return new GymShow(environment, watched, view);
    }

    boolean shows(GymEnvironment other) {
        return environment == other;
    }

    /**
     * Returns two addresses, one in each line: of a page for people, which opens once, and of a file that opens the same page and
     * may stand on a command line.
     */
    String addresses() throws IOException {
        URI file = RedirectPage.write(view.oneTimeAddress()).toUri();
        return view.oneTimeAddress() + "\n" + file;
    }

    @Override
    public void close() {
        watched.leave();
        view.close();
    }
}
