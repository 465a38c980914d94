package org.robonewbie.simulator.server;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robonewbie.simulator.Console;

/** Keeps what the simulator says. */
final class RecordingConsole implements Console {

    private final List<String> sentences = new CopyOnWriteArrayList<>();

    @Override
    public void say(String sentence) {
        sentences.add(sentence);
    }

    List<String> sentences() {
        return sentences;
    }
}
