package org.robonewbie.agent;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;

/** Several agents of one program in the same game. */
final class Game {

    private final Home home;
    private final AtomicInteger exitCode = new AtomicInteger();

    private Game(Home home) {
        this.home = home;
    }

    /**
     * Plays until the game is over for all agents.
     *
     * @return the exit code of the program
     * @throws StartUpException if the game cannot begin
     */
    static int play(List<String> args, List<Agent> agents) {
        check(agents);
        List<Options> options = agents.stream()
                .map(agent -> agent.defaults().overriddenBy(args.toArray(String[]::new)))
                .toList();
        try (Home home = Home.find(options.get(0), agents.size())) {
            System.out.println(home.description());
            return new Game(home).playAll(agents, options);
        }
    }

    private static void check(List<Agent> agents) {
        if (agents.isEmpty()) {
            throw new StartUpException("No agent shall play: give runTogether at least one, such as new MyAgent().");
        }
        if (Set.copyOf(agents).size() < agents.size()) {
            throw new StartUpException(
                    "The same agent shall play twice, but a robot has only one body: make each of them with new.");
        }
    }

    /** The agents connect one after the other, so that each seed gives the same game. */
    private int playAll(List<Agent> agents, List<Options> options) {
        List<Runnable> lives = new ArrayList<>();
        try {
            for (int i = 0; i < agents.size(); i++) {
                Agent agent = agents.get(i);
                Options own = options.get(i);
                LinkPort port = agent.portTo(home);
                lives.add(() -> live(agent, port, own));
            }
        } catch (IOException nobody) {
            throw new StartUpException(String.valueOf(nobody.getMessage()));
        }
        List<Thread> others = lives.stream().skip(1).map(Thread::new).toList();
        others.forEach(Thread::start);
        lives.get(0).run();
        others.forEach(Game::await);
        return exitCode.get();
    }

    private void live(Agent agent, LinkPort port, Options options) {
        int code;
        try {
            code = agent.live(home, port, options);
        } catch (StartUpException refused) {
            System.err.println(refused.getMessage());
            code = 2;
        } catch (IOException lost) {
            System.err.println("The simulator has not let the robot in: " + lost.getMessage());
            code = 2;
        }
        exitCode.accumulateAndGet(code, Math::max);
    }

    private static void await(Thread thread) {
        try {
            thread.join();
        } catch (InterruptedException end) {
            Thread.currentThread().interrupt();
        }
    }
}
