package org.robonewbie.studio;

import org.robonewbie.agent.Nao;

/** A beginner's agent that plays a motion by name from its working directory. */
final class PlaysByName {

    private PlaysByName() {}

    /** Takes the name of the motion and the address of the simulator. */
    public static void main(String[] args) {
        Nao nao = Nao.connect("--host", "127.0.0.1", "--port", args[1]);
        boolean played = nao.perform(args[0]);
        nao.close();
        System.out.println(played ? "played" : "not played");
    }
}
