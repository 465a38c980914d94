package org.robonewbie.learning.environment;

import java.io.IOException;
import java.net.URI;
import org.robonewbie.simulator.embedded.RedirectPage;
import org.robonewbie.simulator.embedded.Viewer;
import org.robonewbie.trial.watch.WatchedTrial;

/** Live view of one environment, which runs in real time while it is displayed and can be paused. */
final class EnvironmentRenderer implements AutoCloseable {

    private final TrainingEnvironment environment;
    private final WatchedTrial watched = new WatchedTrial();
    private final Viewer.View view;

    EnvironmentRenderer(TrainingEnvironment environment, Viewer viewer) throws IOException {
        this.environment = environment;
        view = viewer.open(watched, 0);
        environment.setListener(watched);
    }

    boolean shows(TrainingEnvironment other) {
        return environment == other;
    }

    /**
     * Returns two lines: the one-time address of the page, and the address of a file that redirects to the page, so that
     * the access code does not appear on a command line.
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
