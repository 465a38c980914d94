package org.robonewbie.studio;

import org.robonewbie.agent.Nao;

/** An agent as a beginner writes it: plays the motion of a name, as found in the folder in which it runs. */
final class PlaysByName {

    private PlaysByName() {}

    /** Takes the name of the motion and where the simulator is. */
    public static void main(String[] args) {
        Nao nao = Nao.connect("--host", "127.0.0.1", "--port", args[1]);
        boolean played = nao.perform(args[0]);
        nao.close();
        System.out.println(played ? "played" : "not played");
    }
}
