package org.robonewbie.examples;

import org.robonewbie.agent.Nao;

/**
 * Lesson 1: a robot that says hello. {@code Nao} represents the robot; {@code perform} plays the motion in the file {@code
 * motions/wave.txt} to its end.
 *
 * <p>Try other motions: {@code stand}, {@code walk-forward}, {@code turn-left}.
 */
public final class Agent_Wave {

    private Agent_Wave() {}

    /**
     * Starts the robot.
     *
     * @param args options such as {@code --headless}; {@code --help} lists them
     */
    public static void main(String[] args) {
        try (Nao nao = Nao.connect(args)) {
            nao.say("hello");
            nao.perform("wave");
        }
    }
}
