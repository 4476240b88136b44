// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/VtkMessages.hpp"

#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

namespace isph {

namespace {

class KeptMessages : public vtkOutputWindow {
public:
    static KeptMessages* New();
    vtkTypeMacro(KeptMessages, vtkOutputWindow) void DisplayText(const char* text) override
    {
        note(text);
    }
    void DisplayErrorText(const char* text) override
    {
        failed = true;
        note(text);
    }
    void DisplayWarningText(const char* text) override { note(text); }
    void DisplayGenericWarningText(const char* text) override { note(text); }
    void DisplayDebugText(const char*) override {}

    bool failed = false;
    std::string first;

private:
    void note(const char* text)
    {
        if (!first.empty() || !text) return;
        first = text;
        const auto detail = first.find("): ");  // "ERROR: In file.cxx, line 1\nvtkX (0x...): text"
        if (detail != std::string::npos) first.erase(0, detail + 3);
        first.erase(first.find_last_not_of(" \n") + 1);
    }
};
vtkStandardNewMacro(KeptMessages);

}  // namespace

struct VtkMessages::Content {
    vtkSmartPointer<vtkOutputWindow> windowBefore = vtkOutputWindow::GetInstance();
    vtkLogger::Verbosity verbosityBefore = vtkLogger::GetCurrentVerbosityCutoff();
    vtkNew<KeptMessages> kept;
};

VtkMessages::VtkMessages() : content_(std::make_unique<Content>())
{
    vtkOutputWindow::SetInstance(content_->kept);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

VtkMessages::~VtkMessages()
{
    vtkOutputWindow::SetInstance(content_->windowBefore);
    vtkLogger::SetStderrVerbosity(content_->verbosityBefore);
}

bool VtkMessages::failed() const
{
    return content_->kept->failed;
}
const std::string& VtkMessages::first() const
{
    return content_->kept->first;
}

}  // namespace isph
