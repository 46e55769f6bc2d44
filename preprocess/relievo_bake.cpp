// relievo-bake: from height images and shapes to the maps that shaders search.
#include <CLI/CLI.hpp>

#include "commands/program.h"
#include "preprocess/info_command.h"
#include "preprocess/relief_command.h"
#include "preprocess/sample_command.h"
#include "preprocess/shape_command.h"
#include "preprocess/verify_command.h"

int main(int argc, char** argv) {
    using namespace relievo;
    CLI::App app(
        "Bakes height images into the maps of relief mapping, and shapes into those of "
        "extrusion mapping.",
        "relievo-bake");
    app.require_subcommand(1);
    app.footer(
        "relievo-bake COMMAND --help says more about one.\nExample:\n"
        "  relievo-bake relief bricks.png -o bricks.exr");
    preprocess::ReliefArguments reliefArguments;
    preprocess::ShapeArguments shapeArguments;
    preprocess::InfoArguments infoArguments;
    preprocess::SampleArguments sampleArguments;
    preprocess::VerifyArguments verifyArguments;
    const CLI::App* relief = preprocess::addReliefCommand(app, reliefArguments);
    const CLI::App* shape = preprocess::addShapeCommand(app, shapeArguments);
    const CLI::App* info = preprocess::addInfoCommand(app, infoArguments);
    const CLI::App* verify = preprocess::addVerifyCommand(app, verifyArguments);
    preprocess::addSampleCommand(app, sampleArguments);
    return commands::runProgram(app, argc, argv, [&] {
        if (relief->parsed())
            preprocess::runReliefCommand(reliefArguments);
        else if (shape->parsed())
            preprocess::runShapeCommand(shapeArguments);
        else if (info->parsed())
            preprocess::runInfoCommand(infoArguments);
        else if (verify->parsed())
            preprocess::runVerifyCommand(verifyArguments);
        else
            preprocess::runSampleCommand(sampleArguments);
    });
}
