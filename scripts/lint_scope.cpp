// A plug-in for clang-tidy-14 (scripts/lint.sh): it looks for nothing in what system headers declare, where it would
// report nothing either. Templates of theirs are read, and what our code calls is known to its checks as before; what
// is left out is the way through Eigen's and the standard library's declarations for each of two hundred checks.
#include <clang/AST/ASTConsumer.h>
#include <clang/AST/ASTContext.h>
#include <clang/AST/Decl.h>
#include <clang/Basic/SourceManager.h>
#include <clang/Frontend/FrontendAction.h>
#include <clang/Frontend/FrontendPluginRegistry.h>

#include <memory>
#include <string>
#include <vector>

namespace {

// Runs before clang-tidy's own consumer.
class OwnDeclarations : public clang::ASTConsumer {
 public:
  bool HandleTopLevelDecl(clang::DeclGroupRef group) override {
    for (clang::Decl *decl : group)
      if (!decl->getASTContext().getSourceManager().isInSystemHeader(decl->getLocation())) own_.push_back(decl);
    return true;
  }
  void HandleTranslationUnit(clang::ASTContext &context) override { context.setTraversalScope(own_); }

 private:
  std::vector<clang::Decl *> own_;
};

class Action : public clang::PluginASTAction {
  std::unique_ptr<clang::ASTConsumer> CreateASTConsumer(clang::CompilerInstance &, llvm::StringRef) override {
    return std::make_unique<OwnDeclarations>();
  }
  bool ParseArgs(const clang::CompilerInstance &, const std::vector<std::string> &) override { return true; }
  ActionType getActionType() override { return AddBeforeMainAction; }
};

const clang::FrontendPluginRegistry::Add<Action> added("own-declarations", "passes by system headers");

}  // namespace
